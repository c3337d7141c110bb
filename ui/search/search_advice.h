// SPDX-License-Identifier: GPL-3.0-or-later
// Why a search may have missed servos: the rows of the fault table, the likely ones first, each
// cause with what to check and whether the search itself has ruled it out. The table is data in
// both languages (resources/help/search_checklist.json). Pure; any thread.
#pragma once

#include "catalog/catalog.h"
#include "jobs/scan/scan.h"
#include "session/workbench.h"

namespace ui {
/// What happened before the search.
struct SearchHistory {
    bool idOrBaudChanged = false; ///< by this program since it was started
    int lostServos = 0;           ///< servos that were in the list and did not answer
};

struct SearchFacts {
    jobs::ScanSpec spec;
    jobs::ScanReport report;
    session::PortRequest port;
    bool canSetBaud = true; ///< false: a bridge sets the rate
    /// The protocols tried when none was selected: those possible at the searched baud rates.
    std::vector<base::Protocol> candidates{};
    SearchHistory history{};
    QString otherPrograms{}; ///< that have the port open too, as far as that can be seen
};

struct AdviceItem {
    QString key;
    catalog::Text cause;
    catalog::Text check;   ///< what to look at
    catalog::Text finding; ///< what the search has shown: rules it out, or points at it
    bool ruledOut = false;
};

struct AdviceRow {
    int number = 0; ///< in the fault table
    catalog::Text symptom;
    bool matches = false; ///< what was seen fits; those that do not come last
    std::vector<AdviceItem> items;
};

/// Of the latest search.
SearchFacts searchFacts(const session::Workbench& workbench, const SearchHistory& history);

/// All rows of the table, whatever the result.
std::vector<AdviceRow> searchAdvice(const SearchFacts& facts);

/// True when a wider search is left to try: other IDs, rates or protocols.
bool canSearchWider(const SearchFacts& facts);
} // namespace ui
