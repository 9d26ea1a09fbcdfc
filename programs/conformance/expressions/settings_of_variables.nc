; The value of a setting may begin with a variable; then it is a high-level expression.
num depth = 3, part_width = 4;
#<kept>=depth*2+1
#1=part_width #2=$prog_pos[X]+5
G0 X#<kept> Y[#1 + 1] Z#2
; expect: rapid X7 Y5 Z5
; Functions of brackets stay what they are.
#3=SQRT[16]+1
G0 X#3
; expect: rapid X5
M30
; expect: end and rewind
