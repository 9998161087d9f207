# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m gpswb``."""

import sys

from gpswb.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
