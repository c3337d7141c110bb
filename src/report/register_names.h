// SPDX-License-Identifier: GPL-3.0-or-later
// The names of a servo's registers for a report, in both languages, from the built-in maps, which
// are loaded at the first use. A register that they do not have (a map of the user's own) keeps its
// key. Any thread.
#pragma once

#include "catalog/profile.h"

namespace report {
class RegisterNames {
public:
    /// As a snapshot has them: "STS3215", "3.10".
    RegisterNames(const QString& model, const QString& firmware);
    catalog::Text name(const QString& key) const;

private:
    catalog::ProfilePtr m_profile; ///< null: unknown model
};
} // namespace report
