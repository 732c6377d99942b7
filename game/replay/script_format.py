"""How a script is written: apart from the reader, so that --help needs no pygame."""

FORMAT = """\
script lines (# begins a comment):
  SECONDS key NAME      press a key: return, left, f1, tab, shift+tab, ctrl+return, a, ...
  SECONDS text TEXT     type characters
  SECONDS click X Y     press and release the left mouse button, window pixels
  SECONDS quit          close the window; in a match it asks, and a second quit does
times are game seconds since the start and must not decrease"""
