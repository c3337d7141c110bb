// SPDX-License-Identifier: GPL-3.0-or-later
// Notices under the name device and jobs use. They live in base, so that the text layer can word
// them.
#pragma once

#include "base/notice.h"

namespace device {
using base::Notice;
using base::NoticeCode;
using base::Notices;
} // namespace device
