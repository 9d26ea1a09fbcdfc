(dialect haas)
; AND, OR and XOR take the whole part of a number.
#1=1.9
#2=2.2
#3=#1 OR #2
G0 X#3 Y[7.9 AND 5.5] Z[6.7 XOR 3]
; expect: rapid X3 Y5 Z5
M30
; expect: end and rewind
