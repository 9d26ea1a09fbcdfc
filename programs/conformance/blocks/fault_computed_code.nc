; The rules of a block hold for computed codes, too.
num wanted = 91;
G90 G=wanted X1
M30
; expect error 3:1 E4002
