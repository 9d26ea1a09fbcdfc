%
(AN OUTSIDE THREAD M30X2 WITH A RUN-OUT, THEN A THREAD OF TWO STARTS)
N10 G21 G90 G18 G7 G40 G54
N20 T0101
N30 G97 S600 M3
N40 G95 G0 X32 Z6

(crest 30, depth 1.227 in falling cuts, one spring pass, 2 mm of run-out)
N50 G76 P2 Z-25 I-1 J0.35 K1.227 R2 Q29.5 H1 E2 L2

(two starts of the lead 4, two cuts each)
num cut = 0;
num start = 0;
for (cut = 1; cut <= 2; cut = cut + 1)
{
  for (start = 0; start < 2; start = start + 1)
  {
    G0 X32 Z-34
    G0 X=28-cut*0.8
    G33 Z-58 F4 Q=start*180
    G0 X32
  }
}
N60 G0 X160 Z100
N70 M5
N80 M30
%
