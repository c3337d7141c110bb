// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of a diagnosis: cause, evidence, and what to do, in the language of the interface.
// Causes and remedies follow the fault table of the data sheets, in our own words. Pure; any
// thread.
#pragma once

#include "base/diagnosis.h"

namespace text {
/// One sentence. For ports that could not be opened see error_text.h.
QString causeText(base::Cause cause);
QString causeRemedy(base::Cause cause);
QString evidenceText(const base::Evidence& evidence);
} // namespace text
