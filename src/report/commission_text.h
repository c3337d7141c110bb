// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a commissioning line in both languages at once: what it waits for, what speaks
// against a servo, how one ended. The command line and the window say the same. Constant; any
// thread.
#pragma once

#include "catalog/register.h"
#include "results/commission_batch.h"

namespace report {
using catalog::Text;

/// "voltage alarm", "belongs to another model: STS3215"; an error's name comes back as it is.
Text commissionIssueText(const record::CommissionIssue& issue);
Text commissionIssuesText(const std::vector<record::CommissionIssue>& issues); ///< joined
Text commissionVerdictText(record::CommissionVerdict verdict);                 ///< "Good"
QString commissionVerdictSign(record::CommissionVerdict verdict);              ///< "✔"
} // namespace report
