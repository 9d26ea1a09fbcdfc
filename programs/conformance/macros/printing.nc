(dialect fanuc)
; POPEN, DPRNT, PCLOS (B-63944EN, 16.9): a line of the log.
#100=12.3456
#5=7
POPEN
DPRNT[X#100[53]*T#5[20]]
; expect: log printed X12.346 T7
DPRNT[END]
; expect: log printed END
PCLOS
M30
; expect: end and rewind
