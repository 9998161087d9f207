#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The self-test and the window's tests in Debian 13 with its FreeCAD 1.0: tests/matrix.sh DIRECTORY,
# where the system is made, once (about 2.5 GB). Run as root; its mounts are seen by nobody else.
set -eu
system=$1
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
packages="
    freecad libgl1-mesa-dri python3-hypothesis python3-numpy python3-pytest python3-scipy xauth xvfb
"

if [ ! -e "$system/bare" ]; then
    rm -rf --one-file-system "$system"
    mkdir -p "$system"
    debootstrap --variant=minbase trixie "$system"
    # No service is to start in there, and no documentation is read.
    printf '#!/bin/sh\nexit 101\n' >"$system/usr/sbin/policy-rc.d"
    chmod +x "$system/usr/sbin/policy-rc.d"
    touch "$system/bare"
fi
mkdir -p "$system/gpswb"

export root system packages
unshare --mount sh -eu <<'END'
mount -t proc proc "$system/proc"
mount --rbind /dev "$system/dev"
mount --bind "$root" "$system/gpswb"
cp /etc/resolv.conf "$system/etc/resolv.conf"
inside() {
    chroot "$system" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        DEBIAN_FRONTEND=noninteractive QT_QPA_PLATFORM=offscreen \
        ${OMP_NUM_THREADS:+OMP_NUM_THREADS=$OMP_NUM_THREADS} "$@"
}
if [ "$(cat "$system/installed" 2>/dev/null)" != "$packages" ]; then
    # shellcheck disable=SC2086 # a list of words is meant
    inside apt-get install -q -y --no-install-recommends $packages
    echo "$packages" >"$system/installed"
fi
inside dpkg-query -W -f '${Package} ${Version}\n' freecad libocct-foundation-7.8 python3 python3-numpy
inside freecadcmd -t gpswb.selftest -M /gpswb </dev/null
rm -f "$root/build/freecad/passed"
inside GPSWB_TESTS="tests/freecad/test_addon_metadata.py tests/freecad/test_annotation_objects.py
    tests/freecad/test_frame_places.py tests/freecad/test_measured_objects.py
    tests/freecad/test_measured_partition.py tests/freecad/test_partition_object.py" \
    freecadcmd /gpswb/tests/freecad/run_pytest.py </dev/null
[ -e "$root/build/freecad/passed" ]
inside sh /gpswb/tests/gui/run.sh /gpswb/build/gui-matrix
END
