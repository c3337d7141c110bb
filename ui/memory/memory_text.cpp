// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_text.h"

#include "catalog/raw_range.h"
#include "device/write_meaning.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/translate.h"

namespace ui {
using catalog::Encoding;
using text::translate;

namespace {
const QString dash = QStringLiteral("—");
const QString changedMark = QStringLiteral("  •");

QString accessCellText(const MemoryRow& row)
{
    if (!row.isWritable)
        return translate("MemoryTable", "r", "read-only");
    const QString both = translate("MemoryTable", "rw", "read/write");
    return device::alwaysNeedsConsent(*row.reg) ? QStringLiteral("⚠ ") + both : both;
}

QString accessHelp(const MemoryRow& row)
{
    if (!row.isWritable)
        return text::accessLabel(catalog::Access::ReadOnly);
    const QString word = text::accessLabel(catalog::Access::ReadWrite);
    return device::alwaysNeedsConsent(*row.reg)
               ? translate("MemoryTable",
                           "%1. A wrong value can make the servo unreachable or dangerous. "
                           "ServoDesk asks for confirmation before each write.")
                     .arg(word)
               : word;
}

QString defaultText(const MemoryRow& row, bool physical)
{
    if (!row.reg->defaultRaw)
        return {};
    return physical && !hasNamedValues(row.meaning)
               ? physicalText(*row.reg->defaultRaw, *row.reg, row.meaning)
               : QString::number(*row.reg->defaultRaw);
}

QString physicalCellText(const MemoryRow& row)
{
    if (!row.raw)
        return {};
    if (!row.hasSensor)
        return translate("MemoryTable", "not measured");
    return physicalText(*row.raw, *row.reg, row.meaning);
}
} // namespace

QString memoryHeader(MemoryColumn column)
{
    switch (column) {
    case MemoryColumn::Address:
        return translate("MemoryTable", "Address");
    case MemoryColumn::Name:
        return translate("MemoryTable", "Register");
    case MemoryColumn::Value:
        return translate("MemoryTable", "Value");
    case MemoryColumn::Physical:
        return translate("MemoryTable", "Physical");
    case MemoryColumn::Area:
        return translate("MemoryTable", "Area");
    case MemoryColumn::Access:
        return translate("MemoryTable", "Access");
    case MemoryColumn::Default:
        return translate("MemoryTable", "Default");
    case MemoryColumn::Range:
        return translate("MemoryTable", "Range");
    case MemoryColumn::State:
        return translate("MemoryTable", "State");
    case MemoryColumn::Count:
        break;
    }
    return {};
}

QString memoryHeaderHelp(MemoryColumn column)
{
    switch (column) {
    case MemoryColumn::Address:
        return translate("MemoryTable", "Address in the servo's memory table");
    case MemoryColumn::Name:
        return translate(
            "MemoryTable",
            "Register name; • marks a value that differs from the first reading of this session");
    case MemoryColumn::Value:
        return translate("MemoryTable", "Raw value as read from the servo");
    case MemoryColumn::Physical:
        return translate("MemoryTable",
                         "Raw value converted to physical units, or the name it stands for");
    case MemoryColumn::Area:
        return translate("MemoryTable",
                         "Memory area: EPROM (kept after power-off), SRAM (lost at power-off), "
                         "feedback (measured) or factory (set by the manufacturer)");
    case MemoryColumn::Access:
        return translate("MemoryTable",
                         "r: read-only; rw: read/write; ⚠: requires confirmation for each write");
    case MemoryColumn::Default:
        return translate("MemoryTable", "Factory value; empty if unknown");
    case MemoryColumn::Range:
        return translate("MemoryTable", "Values that can be written");
    case MemoryColumn::State:
        return translate("MemoryTable", "Result of the last write and age of the value");
    case MemoryColumn::Count:
        break;
    }
    return {};
}

QString registerName(const MemoryRow& row)
{
    return text::localized(row.meaning.name);
}

QString memoryText(const MemoryRow& row, MemoryColumn column, bool physicalFirst)
{
    switch (column) {
    case MemoryColumn::Address:
        return QString::number(row.reg->address);
    case MemoryColumn::Name:
        return row.isChanged() ? registerName(row) + changedMark : registerName(row);
    case MemoryColumn::Value:
        return row.raw ? QString::number(*row.raw) : dash;
    case MemoryColumn::Physical:
        return physicalCellText(row);
    case MemoryColumn::Area:
        return text::areaLabel(row.reg->area);
    case MemoryColumn::Access:
        return accessCellText(row);
    case MemoryColumn::Default:
        return defaultText(row, physicalFirst);
    case MemoryColumn::Range:
        return row.isWritable ? rangeText(*row.reg, row.meaning, physicalFirst) : QString();
    case MemoryColumn::State:
        return stateText(row);
    case MemoryColumn::Count:
        break;
    }
    return {};
}

QString memoryTip(const MemoryRow& row, MemoryColumn column, bool physicalFirst)
{
    switch (column) {
    case MemoryColumn::Address:
        return QStringLiteral("%1 (0x%2), %3")
            .arg(row.reg->address)
            .arg(row.reg->address, 2, 16, QLatin1Char('0'))
            .arg(row.reg->key);
    case MemoryColumn::Name:
        return row.isChanged()
                   ? translate("MemoryTable", "%1: was %2 when first read in this session")
                         .arg(registerName(row))
                         .arg(*row.firstRaw)
                   : registerName(row);
    case MemoryColumn::Value:
    case MemoryColumn::Physical:
        return row.raw ? rawWord(*row.raw, *row.reg, row.meaning) : stateHelp(row);
    case MemoryColumn::Access:
        return accessHelp(row);
    case MemoryColumn::Default:
        return row.reg->defaultRaw
                   ? rawWord(*row.reg->defaultRaw, *row.reg, row.meaning)
                   : translate("MemoryTable", "No default is known for this model.");
    case MemoryColumn::Range: {
        const QString range = memoryText(row, column, physicalFirst);
        return range.isEmpty() ? translate("MemoryTable", "This register cannot be written.")
                               : translate("MemoryTable", "Values that can be written: %1")
                                     .arg(rangeText(*row.reg, row.meaning, false));
    }
    case MemoryColumn::State:
        return stateHelp(row);
    case MemoryColumn::Area:
    case MemoryColumn::Count:
        break;
    }
    return memoryText(row, column, physicalFirst);
}
} // namespace ui
