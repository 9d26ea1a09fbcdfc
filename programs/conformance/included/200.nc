(a program in a file of its own, without its number)
G0 Y[#1 + 1]
M99
