; Each faulty O-line is said once, whatever it encloses.
O1 while [1
  G0 X1
O1 endwhile
; expect error 2:12 E2001
O2 if [1]
O3 endif
; expect error 7:1 E2013
O2 endif
O4 break
; expect error 10:1 E3016
O5 endrepeat
; expect error 12:1 E2013
O6 call [1] G0
; expect error 14:13 E2001
O7 call
; expect error 16:1 E7005
{ O8
}
; expect error 18:3 E2012
O9 return
; expect error 21:1 E3016
O<title>
; expect error 23:1 E2001
O10 iff [1]
; expect error 25:1 E2001
O11 sub
O12 sub
; expect error 28:1 E2012
O11 endsub
#5=2 #<_x>=1
; expect error 31:6 E3013
M30
