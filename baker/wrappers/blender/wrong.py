# SPDX-License-Identifier: MIT
class Wrong(Exception):
    """Error that the user can put right, in one line."""
