"""Tests, a folder for each part of the program; data and cases lie beside the folders."""
