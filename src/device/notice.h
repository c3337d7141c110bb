// SPDX-License-Identifier: GPL-3.0-or-later
// Notices under the name that device and jobs use. They live in base, so that the text layer can
// describe them.
#pragma once

#include "base/notice.h"

namespace device {
using base::Notice;
using base::NoticeCode;
using base::Notices;
} // namespace device
