// SPDX-License-Identifier: MIT
#include "support/within.h"
