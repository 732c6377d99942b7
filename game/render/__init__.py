"""Everything that puts pixels on a surface: given plain numbers, it draws and keeps no game state.

Screen points are continuous: pixel (i, j) covers [i, i + 1] x [j, j + 1], its centre is at + 0.5.
Table points are metres from the centre, x to the right and y up, away from the viewer.
Every function that draws returns the rectangle it may have changed.
"""
