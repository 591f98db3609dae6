# SPDX-License-Identifier: MIT
class Wrong(Exception):
    """An error that the user can put right, described in one line."""
