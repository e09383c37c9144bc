BEGIN Y-AXIS.COM MM
NR   AXISPOS   BACKLASH   Y
0    -90       +0.002     +0.001
1    -85                  -0.003
[END]
