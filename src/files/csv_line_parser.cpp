// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv_line_parser.h"

#include <algorithm>

namespace files {
std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
        text.remove_suffix(1);
    return text;
}

const std::vector<std::string_view>& CsvLineParser::split(std::string_view line)
{
    m_cells.clear();
    m_unquoted.clear();
    std::size_t begin = 0;
    while (true) {
        // Most cells are empty: they belong to the other servos.
        while (begin < line.size() && line[begin] == ',') {
            m_cells.emplace_back();
            ++begin;
        }
        std::size_t end = 0;
        if (begin < line.size() && line[begin] == '"') {
            end = parseQuoted(line, begin);
        } else {
            end = std::min(line.find(',', begin), line.size());
            m_cells.push_back(trimmed(line.substr(begin, end - begin)));
        }
        if (end >= line.size())
            return m_cells;
        begin = end + 1;
    }
}

/// The position of the comma after it, or the end.
std::size_t CsvLineParser::parseQuoted(std::string_view line, std::size_t begin)
{
    std::string& text = m_unquoted.emplace_back();
    std::size_t i = begin + 1;
    for (; i < line.size(); ++i) {
        if (line[i] == '"' && (i + 1 == line.size() || line[i + 1] != '"'))
            break;
        text += line[i];
        i += line[i] == '"' ? 1 : 0;
    }
    const std::size_t comma = std::min(line.find(',', std::min(i, line.size())), line.size());
    m_cells.push_back(text);
    return comma;
}
} // namespace files
