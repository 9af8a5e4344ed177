# SPDX-License-Identifier: LGPL-2.1-or-later
"""How layers are filled: one module a strategy; ``registry`` says what it must have."""
