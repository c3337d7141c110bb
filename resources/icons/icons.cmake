# The icons of the program, inside it: the few of the Breeze theme that are used, in both colours,
# so that they appear on systems without the theme. Copied at configure time from the packages
# breeze-icon-theme (LGPL-3.0-or-later, KDE Visual Design Group); names in names.txt.
