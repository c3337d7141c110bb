// SPDX-License-Identifier: GPL-3.0-or-later
// The base of all editors of a register value: they show a raw number, take what the user types,
// checks or selects, and report what is wrong with it. They write nothing. makeRegisterEditor()
// alone decides which editor a register gets, in a cell and in the help panel. Owned by their
// parent; main thread.
#pragma once

#include "catalog/value.h"

#include <QWidget>

namespace ui {
struct EditContext {
    const catalog::Register* reg = nullptr; ///< outlives the editor
    catalog::ValueFormat meaning;
    std::optional<std::int64_t> currentRaw; ///< as read: may always be written back
    bool inPhysicalUnit = false;            ///< numbers in their unit
    bool inCell = false;                    ///< small, framed, above its neighbors
    bool ownerHandlesEnter = false;         ///< outside a cell: the owner takes Enter
};

class RegisterEditor : public QWidget {
    Q_OBJECT

public:
    RegisterEditor(EditContext context, QWidget* parent);

    const EditContext& context() const { return m_context; }
    /// The present values of the registers that decide its meaning.
    void setContext(const EditContext& context);

    /// Nullopt: nothing is known, the editor starts empty. Not a change by the user.
    virtual void setRaw(std::optional<std::int64_t> raw) = 0;
    virtual QString inputText() const = 0;
    /// BadArgument, ReadOnly, OutOfRange.
    base::Result<std::int64_t> value() const;
    /// Why value() fails, in words; empty when all is well.
    QString inputError() const;
    bool isModified() const { return m_modified; } ///< by the user, since setRaw()

    /// The widgets that take keys, for the delegate's event filter.
    virtual QList<QWidget*> is() const = 0;
    virtual void selectAll() {}

Q_SIGNALS:
    void userEdited();  ///< by the user
    void valueChosen(); ///< selected from a list: the input is complete

protected:
    virtual base::Result<std::int64_t> parse() const;
    virtual void contextChanged() {}
    QString keyHint() const; ///< what Enter and Esc do here
    void markModified();
    void clearModified() { m_modified = false; }

private:
    EditContext m_context;
    bool m_modified = false;
};

RegisterEditor* makeRegisterEditor(const EditContext& context, QWidget* parent);
} // namespace ui
