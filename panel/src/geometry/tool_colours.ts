// Colours that can be told apart without red and green, for surfaces by the tool that made them. Source:
// M. Okabe and K. Ito, Color Universal Design (2008).

const blank = '#b8bcc2';
const palette = ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#0072b2', '#d55e00', '#f0e442'];

/** Number 0 is the blank's own surface. */
export function colourOfTool(number: number): string {
  return number === 0 ? blank : (palette[(number - 1) % palette.length] ?? blank);
}
