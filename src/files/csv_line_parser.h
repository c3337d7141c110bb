// SPDX-License-Identifier: GPL-3.0-or-later
// A line of CSV, without its end, as cells: quotes taken off, blanks around unquoted ones too. Any
// text is some cells; nothing fails. Owned by a reader, its thread.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace files {
/// Without the blanks around it.
std::string_view trimmed(std::string_view text);

class CsvLineParser {
public:
    /// Valid until the next call, and as long as `line`.
    const std::vector<std::string_view>& split(std::string_view line);

private:
    std::size_t parseQuoted(std::string_view line, std::size_t begin);

    std::vector<std::string_view> m_cells;
    std::deque<std::string> m_unquoted;
};
} // namespace files
