; A way is `vector` or `axis`.
#orientation (circle)
; expect error 2:15 E2001
M30
