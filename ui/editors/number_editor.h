// SPDX-License-Identifier: GPL-3.0-or-later
// A number, raw or in its unit, with steps up and down inside the documented range. Any text can be
// typed or pasted; text that is not understood is reported, never changed silently. Owned by its
// parent; main thread.
#pragma once

#include "ui/editors/register_editor.h"

#include <QAbstractSpinBox>

namespace ui {
class NumberSpin;

class NumberEditor final : public RegisterEditor {
    Q_OBJECT

public:
    NumberEditor(const EditContext& context, QWidget* parent);

    void setRaw(std::optional<std::int64_t> raw) override;
    QString inputText() const override;
    QList<QWidget*> is() const override;
    void selectAll() override;

    /// As if the user had typed it.
    void enterValue(std::int64_t raw);

    /// The raw number that many steps away, inside the range.
    std::int64_t valueAfterSteps(int steps) const;

protected:
    base::Result<std::int64_t> parse() const override;
    void contextChanged() override;

private:
    friend class NumberSpin;
    void show(std::int64_t raw);
    void retranslate();

    NumberSpin* m_spin;
    std::optional<std::int64_t> m_start;
};

/// The box itself: text is free, arrows step.
class NumberSpin final : public QAbstractSpinBox {
    Q_OBJECT

public:
    explicit NumberSpin(NumberEditor& editor);

    void setText(const QString& text);
    QString typedText() const;
    void stepBy(int steps) override;
    QValidator::State validate(QString& input, int& position) const override;

Q_SIGNALS:
    void textEdited();

protected:
    StepEnabled stepEnabled() const override;

private:
    NumberEditor& m_editor;
};
} // namespace ui
