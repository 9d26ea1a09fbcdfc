# Pictures of docs/developer/motion.md from the CSV files of contour_feed_figures; see there for the command.
set datafile separator ','
set terminal svg size 900,460 font 'DejaVu Sans,12' background '#ffffff'
set border 3 lc rgb '#5c6b73'
set tics nomirror
set grid lc rgb '#dde3e7' lw 1
blue = '#1f4e79'; red = '#c8553d'; green = '#3a7d44'; gold = '#b8860b'; violet = '#7a5c99'

set output pictures.'/feed-increments.svg'
set multiplot layout 1,2 title 'Speed error of position increments, 1 kHz, 1000 increments per mm'
set xlabel 'feed, mm/min'
set ylabel 'error, %'
set key top right
set xrange [1:100]
set yrange [-200:1000]
plot data.'/increments.csv' skip 1 using 1:3 with lines lw 2 lc rgb red title 'highest', \
     '' skip 1 using 1:2 with lines lw 2 lc rgb blue title 'lowest'
set xrange [1000:60000]
set yrange [-6:6]
set xtics 20000
unset ylabel
plot data.'/increments.csv' skip 1 using 1:3 with lines lc rgb red notitle, \
     '' skip 1 using 1:2 with lines lc rgb blue notitle
unset multiplot

set output pictures.'/feed-kmv.svg'
set title 'Error of the contour speed by the velocity code, circle R20, 1 kHz, 1000 increments per mm'
set xlabel 'kmv'
set ylabel 'largest error, %'
set logscale xy
set format xy '10^{%L}'
set xrange [1:1e6]
set yrange [1e-8:1e4]
set xtics autofreq
set key outside right top title 'feed, mm/min'
speed_error(feed) = sprintf("< awk -F, '$2 == %d' %s/velocity_codes.csv", feed, data)
plot for [k=1:5] speed_error(word('1 60 1000 6000 60000', k) + 0) using 1:4 with lines dt 2 \
       lc rgb word('#1f4e79 #c8553d #3a7d44 #b8860b #7a5c99', k) notitle, \
     for [k=1:5] speed_error(word('1 60 1000 6000 60000', k) + 0) using 1:3 with linespoints pt 7 \
       ps 0.6 lw 2 lc rgb word('#1f4e79 #c8553d #3a7d44 #b8860b #7a5c99', k) \
       title word('1 60 1000 6000 60000', k), \
     NaN with lines dt 2 lc rgb '#5c6b73' title 'eq. (15)'

set output pictures.'/following-error.svg'
set title 'Following error on a circle R20, rms of both axes, simulated drive, kp = 40 1/s'
set xlabel 'feed, mm/min'
set ylabel 'error, um'
set xrange [1000:18000]
set yrange [0.01:20000]
set format x '%g'
set xtics (1000, 2000, 3000, 6000, 12000, 18000)
set key outside right top notitle
law(number) = sprintf("< awk -F, '$2 == %d' %s/following.csv", number, data)
plot for [n=0:3] law(n) using 1:3 with linespoints pt 7 ps 0.6 lw 2 \
       lc rgb word('#5c6b73 #1f4e79 #3a7d44 #b8860b', n + 1) \
       title word('kp +kv +ka +kr', n + 1), \
     law(3) using 1:4 with linespoints pt 6 ps 0.6 lw 2 dt 2 lc rgb red \
       title 'all, by differences'

set output pictures.'/controller-demand.svg'
set title 'Velocity demand U of one axis with kv, ka and kr, circle R20, F6000'
unset logscale
set format xy '%g'
set xtics autofreq
set xlabel 'time, s'
set ylabel 'U, mm/s'
set xrange [0:0.1]
set autoscale y
set key inside top left notitle
plot data.'/demand.csv' skip 1 using 1:3 with steps lc rgb red \
       title 'differences of integer positions', \
     '' skip 1 using 1:2 with lines lw 2 lc rgb blue title 'derivatives of the interpolator'
