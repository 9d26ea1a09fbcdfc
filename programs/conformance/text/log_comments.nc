; Comments of LinuxCNC that log (LinuxCNC, "G-Code Overview", 11.3): the log is open always.
#1=2.5
#<size>=3
(LOGOPEN,sizes.txt)
(LOG,%.1fsize #<size> and #1)
; expect: log size 3.0 and 2.5
(logappend,sizes.txt)
(log, end)
; expect: log end
(LOGCLOSE)
M30
; expect: end and rewind
