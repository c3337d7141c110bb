// SPDX-License-Identifier: GPL-3.0-or-later
// What servos of the four Feetech maps say they are.
#pragma once

#include "catalog/profile.h"

const catalog::Identity Sts{3, 10, 0, 9, 3};
const catalog::Identity Sms{2, 53, 0, 8, 42};
const catalog::Identity Scs15{0, 4, 1, 5, 15};
const catalog::Identity Scs45{0, 4, 1, 5, 12}; // range not known
