#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs a script in FreeCAD's window, on a screen that nobody sees: run.sh DIRECTORY [SCRIPT].
# Settings, pictures and the file `passed`, which the script leaves, go into the directory. FreeCAD
# gets settings of its own, and finds the workbench as a user's add-on. The script runs the tests of
# the window if none is named.
set -eu
out=$1
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
script=${2:-$root/tests/gui/run_gui.py}

rm -rf "$out"
# FreeCAD before 1.1 and from 1.1 on; in the second case anything beside the versioned directory
# would bring up a dialog that asks whether to migrate it.
version=$(dpkg-query -W -f '${Version}' freecad)
if dpkg --compare-versions "$version" ge 1.1; then place=FreeCAD/v1-1; else place=FreeCAD; fi
mkdir -p "$out/config/$place" "$out/data/$place/Mod" "$out/pictures"
ln -s "$root" "$out/data/$place/Mod/gpswb"
cp "$root/tests/gui/user.cfg" "$out/config/$place/user.cfg"

export XDG_CONFIG_HOME="$out/config" XDG_DATA_HOME="$out/data" XDG_CACHE_HOME="$out/cache"
export GPSWB_GUI_PASSED="$out/passed" GPSWB_GUI_PICTURES="$out/pictures"
# FreeCAD 0.20 starts no web engine as root without the last one.
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb QTWEBENGINE_DISABLE_SANDBOX=1
timeout "${GPSWB_GUI_LIMIT:-900}" \
    xvfb-run -a -s "-screen 0 1280x800x24 -dpi 96 +extension GLX" freecad "$script" </dev/null || true
[ -e "$out/passed" ]
