# SPDX-License-Identifier: MIT
class Wrong(Exception):
    """What the user can put right, in one line."""
