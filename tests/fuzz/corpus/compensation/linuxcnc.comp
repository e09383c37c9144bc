# Palmer LinuxCNC compensation axis=X unit=mm values=perDirection
# COMP_FILE_TYPE = 0: nominal, actual going forward, actual going back
0 -0.003 0.0023
100 100.0002 100.0054
