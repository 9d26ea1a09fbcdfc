// Engraving of text with a font of single strokes.
//
// Letters stand on a grid of 4 by 6, 6 from letter to letter. A stroke is pairs of digits, X and Y
// of its corners; a blank begins the next one. Small letters are engraved as capitals.

string engrave_strokes (string letter) {
  switch (letter) {
    case "A": { return "002640 1333"; }
    case "B": { return "000636454433033342413000"; }
    case "C": { return "4130100105163645"; }
    case "D": { return "00062644422000"; }
    case "E": { return "40000646 0333"; }
    case "F": { return "000646 0333"; }
    case "G": { return "45361605011030414323"; }
    case "H": { return "0006 4046 0343"; }
    case "I": { return "1030 2026 1636"; }
    case "J": { return "4641301001"; }
    case "K": { return "0006 460340"; }
    case "L": { return "060040"; }
    case "M": { return "0006234640"; }
    case "N": { return "00064046"; }
    case "O": { return "103041453616050110"; }
    case "P": { return "00063645443303"; }
    case "Q": { return "103041453616050110 2240"; }
    case "R": { return "00063645443303 2340"; }
    case "S": { return "011030414233130405163645"; }
    case "T": { return "0646 2026"; }
    case "U": { return "060110304146"; }
    case "V": { return "062046"; }
    case "W": { return "0610233046"; }
    case "X": { return "0046 0640"; }
    case "Y": { return "062346 2320"; }
    case "Z": { return "06460040"; }
    case "0": { return "103041453616050110 0145"; }
    case "1": { return "152620 1030"; }
    case "2": { return "05163645440040"; }
    case "3": { return "05163645443313 334241301001"; }
    case "4": { return "30360242"; }
    case "5": { return "460603334241301001"; }
    case "6": { return "453616050110304142331302"; }
    case "7": { return "064610"; }
    case "8": { return "13040516364544331302011030414233"; }
    case "9": { return "011030414536160504133344"; }
    case "-": { return "1333"; }
    case "+": { return "0343 2125"; }
    case ".": { return "2021"; }
    case ",": { return "2110"; }
    case ":": { return "2122 2425"; }
    case "/": { return "0046"; }
    case "=": { return "0242 0444"; }
    case "(": { return "36252130"; }
    case ")": { return "16252110"; }
    case "_": { return "0040"; }
    case "'": { return "2625"; }
    case "!": { return "2021 2326"; }
    case "?": { return "2021 22233445361605"; }
    case " ": { return ""; }
    default: { terminate (4403, "the font has no letter " + letter); }
  }
  return "";
}

// From the corner at (`from_x`, `from_y`), its X and Y along the line of text: one letter.
// `feed` and `plunge` 0: the feed that is active.
void engrave_letter (string strokes, num from_x, num from_y, num scale, num angle, num at_z,
                     num feed, num plunge) {
  num height = $prog_pos[Z];
  bool is_down = false;
  for (num idx = 0; idx < len (strokes); idx += 2) {
    if (substr (strokes, idx, 1) == " ") {
      G0 Z=height
      is_down = false;
      idx += 1;
    }
    num along = scale*to_num (substr (strokes, idx, 1));
    num up = scale*to_num (substr (strokes, idx + 1, 1));
    num to_x = from_x + along*cos (angle) - up*sin (angle);
    num to_y = from_y + along*sin (angle) + up*cos (angle);
    if (is_down) {
      if (feed > 0) { F=feed }
      G1 X=to_x Y=to_y
    } else {
      G0 X=to_x Y=to_y
      if (plunge > 0) { F=plunge }
      G1 Z=at_z
      is_down = true;
    }
  }
  G0 Z=height
}

// `text` in letters of `height`, down to `at_z`, in the direction `angle`. The lower left corner of
// the first letter is where the tool stands, which ends where the next one would begin. `feed` along
// the strokes, `plunge` into the material; 0: the feed that is active.
void engrave (string text, num height, num at_z, num angle = 0, num feed = 0, num plunge = 0) {
  M73
  if (height <= 0) { terminate (4403, "the height of letters must be above 0"); }
  if (plunge > 0 && feed <= 0) { terminate (4403, "a feed for plunging also needs a feed along the strokes"); }
  for (num idx = 0; idx < len (text); idx++) { engrave_strokes (upper (substr (text, idx, 1))); }
  G90 G17
  num from_x = $prog_pos[X], from_y = $prog_pos[Y];
  for (num idx = 0; idx < len (text); idx++) {
    string strokes = engrave_strokes (upper (substr (text, idx, 1)));
    if (len (strokes) > 0) {
      engrave_letter (strokes, from_x + idx*height*cos (angle), from_y + idx*height*sin (angle),
                      height/6, angle, at_z, feed, plunge);
    }
  }
  G0 X=from_x+len(text)*height*cos(angle) Y=from_y+len(text)*height*sin(angle)
}

// G47 of Haas programs: `text` from at_x, at_y on, with the tool at `retract` between strokes.
void engrave_block (string text, num at_x, num at_y, num angle, num height, num retract, num at_z,
                    num feed, num plunge) {
  M73
  G90
  if ($prog_pos[Z] < retract) { G0 Z=retract }
  G0 X=at_x Y=at_y
  if ($prog_pos[Z] > retract) { G0 Z=retract }
  engrave (text, height, at_z, angle, feed, plunge > 0 ? plunge : feed);
}

// G47 P1 of Haas programs: a number of so many digits between two texts.
void engrave_number (num number, num digits, string before, string behind, num at_x, num at_y, num angle,
                     num height, num retract, num at_z, num feed, num plunge) {
  string text = str (number, 0);
  if (number < 0 || len (text) > digits) {
    terminate (4403, "the serial number " + text + " has more digits than #");
  }
  while (len (text) < digits) { text = "0" + text; }
  engrave_block (before + text + behind, at_x, at_y, angle, height, retract, at_z, feed, plunge);
}
