# Pictures of docs/programmer/feed-laws.md from the tip traces of two example programs; see there for the command.
set datafile separator ','
set terminal svg size 900,420 font 'DejaVu Sans,12' background '#ffffff'
set border 3 lc rgb '#5c6b73'
set tics nomirror
set grid lc rgb '#dde3e7' lw 1
set ylabel 'feed, mm/min'
set key off
blue = '#1f4e79'; red = '#c8553d'
rows(file, line) = sprintf("< awk -F, '$2 == %d' %s/%s.csv", line, data, file)

# The program's feed in steps, and the speed of the tool along Z.
set output pictures.'/feed-law-linear.svg'
set multiplot layout 1,2 title 'Linear feed: S\_n=240 S\_k=120 dS=0.5 over 59 mm'
set yrange [0:260]
set xlabel 'path, mm'
plot rows('slender_shaft', 12) every 20 using (-1 - $5):($3 * 60) with lines lw 2 lc rgb blue
set xlabel 'time, s'
plot rows('slender_shaft', 12) every 20 using ($0 / 50):($3 * 60) with lines lw 2 lc rgb blue
unset multiplot

set output pictures.'/feed-law-modulated.svg'
set multiplot layout 1,2 title 'Modulated feed: Smin=0.10 dS=0.01 dl=0.2 n\_s=20 at 600 rev/min'
set yrange [0:200]
set xlabel 'path, mm'
plot rows('chip_breaking', 10) every 20 using (2 - $5):($3 * 60) with lines lw 2 lc rgb blue
set xlabel 'time, s'
plot rows('chip_breaking', 10) every 20 using ($0 / 50):($3 * 60) with lines lw 2 lc rgb blue
unset multiplot

set output pictures.'/feed-law-interrupted.svg'
set title 'Interrupted feed: L\_A=0.4 L\_B=2 at F120; the chip ends where the tool stands for two revolutions'
set yrange [0:*]
set xrange [0:6]
set xlabel 'time, s'
set ylabel 'path, mm'
set y2label 'speed, mm/min'
set y2range [0:200]
set y2tics
set key top left
plot rows('chip_breaking', 16) every 20 using ($0 / 50):(2 - $5) with lines lw 2 lc rgb blue title 'path', \
     '' every 20 using ($0 / 50):(-$8 * 60) axes x1y2 with lines lw 1 lc rgb red title 'speed'
