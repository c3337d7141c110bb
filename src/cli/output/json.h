// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that keeps the order in which members were added. A value; any thread; never fails.
// Top-level members and the elements of their lists are on separate lines.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace cli {
class Json {
public:
    using Array = std::vector<Json>;
    using Object = std::vector<std::pair<QString, Json>>;

    Json(); ///< null
    Json(bool value);
    Json(int value);
    Json(std::int64_t value);
    Json(double value);
    Json(QString value);
    Json(const char*) = delete; ///< would be a bool
    Json(const QStringList& values);
    Json(Array values);
    Json(Object members);
    template <typename T>
    Json(const std::optional<T>& value)
        : Json(value ? Json(*value) : Json())
    {}

    // Not inline, because the compiler then warns about moving a variant.
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(const Json& other);
    Json& operator=(Json&& other) noexcept;
    ~Json();

    static Json object() { return Json(Object()); }

    /// Appends a member to an object.
    Json& add(const char* name, Json value);

    QByteArray text() const;    ///< several lines with a final line feed
    QByteArray compact() const; ///< one line without a line feed

private:
    void write(QByteArray& out, int depth) const;
    template <typename Parts, typename WritePart>
    void writeParts(QByteArray& out, char open, char close, const Parts& parts, int depth,
                    const WritePart& writePart) const;

    std::variant<std::monostate, bool, std::int64_t, double, QString, Array, Object> m_value;
};
} // namespace cli
