// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of a commissioning batch in both languages: problems of a servo, and how its
// commissioning ended. Command line and window show the same. Constant; any thread.
#pragma once

#include "catalog/register.h"
#include "results/commission_batch.h"

namespace report {
using catalog::Text;

/// "voltage alarm", "another servo replies now: STS3215"; a name without a text comes back as it
/// is.
Text commissionIssueText(const results::CommissionIssue& issue);
Text commissionIssuesText(const std::vector<results::CommissionIssue>& issues); ///< joined
Text commissionVerdictText(results::CommissionVerdict verdict);                 ///< "Good"
QString commissionVerdictSign(results::CommissionVerdict verdict);              ///< "✔"
} // namespace report
