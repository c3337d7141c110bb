// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/place.h"

#include <algorithm>
#include <map>

namespace catalog {
namespace {
constexpr int FeetechBytes = 256;
constexpr int ModbusBytes = 2;   // of one register
constexpr int LxParameters = 8;  // bytes of the table an LX command owns
constexpr int LxLongestList = 4; // parameters of the longest command of the sheet
constexpr int LxCommands = TableBytes / LxParameters;

int requiredInteger(Fields& fields, const char* name, int min, int max)
{
    fields.require(name);
    return static_cast<int>(fields.integer(name, min, max).value_or(min));
}

void readFeetechPlace(Fields& fields, Register& reg)
{
    reg.address = requiredInteger(fields, "address", 0, FeetechBytes - 1);
    if (reg.address + reg.size > FeetechBytes)
        fields.complain(QStringLiteral("the register reaches beyond address 255"));
    reg.offset = reg.writeOffset = reg.address;
}

void readModbusPlace(Fields& fields, Register& reg)
{
    reg.address = requiredInteger(fields, "address", 0, TableBytes / ModbusBytes - 1);
    if (reg.size != ModbusBytes)
        fields.complain(QStringLiteral("\"size\" of a Modbus register must be 2"));
    reg.offset = reg.writeOffset = ModbusBytes * reg.address;
}

void readLxPlace(Fields& fields, Register& reg)
{
    reg.address = requiredInteger(fields, "address", 1, LxCommands - 1);
    const int place = requiredInteger(fields, "place", 1, LxLongestList);
    if (place + reg.size - 1 > LxLongestList)
        fields.complain(QStringLiteral("the register reaches beyond the parameters"));
    const auto write = fields.integer("write", 1, LxCommands - 1);
    const auto save = fields.integer("save", 1, LxCommands - 1);
    reg.offset = LxParameters * reg.address + place - 1;
    reg.writeOffset = write ? LxParameters * static_cast<int>(*write) + place - 1 : reg.offset;
    reg.saveOffset = save ? LxParameters * static_cast<int>(*save) : -1;
    if (save && !write)
        fields.complain(QStringLiteral("\"save\" needs \"write\""));
}

template <typename Visit>
void eachDefinition(MapDef& map, Visit visit)
{
    for (RegisterRow& row : map.rows) {
        visit(row.base.reg);
        for (auto& [condition, def] : row.set)
            visit(def.reg);
    }
}
} // namespace

void readPlace(Fields& fields, Register& reg, base::Protocol protocol)
{
    reg.size = requiredInteger(fields, "size", 1, 4);
    if (reg.size == 3)
        fields.complain(QStringLiteral("\"size\" must be 1, 2 or 4"));
    switch (protocol) {
    case base::Protocol::Feetech:
        return readFeetechPlace(fields, reg);
    case base::Protocol::Modbus:
        return readModbusPlace(fields, reg);
    case base::Protocol::Lx:
        return readLxPlace(fields, reg);
    }
}

void formBlocks(MapDef& map)
{
    if (map.protocol != base::Protocol::Lx)
        return;
    std::map<int, Block> blocks; // by read command
    eachDefinition(map, [&](Register& reg) {
        Block& block = blocks[reg.address];
        const int first = LxParameters * reg.address;
        block.offset = first;
        block.size = std::max(block.size, reg.offset + reg.size - first);
        if (reg.writable())
            block.writeOffset = reg.writeOffset - (reg.offset - first);
        else if (block.writeOffset == 0)
            block.writeOffset = first;
    });
    eachDefinition(map, [&](Register& reg) { reg.block = blocks[reg.address]; });
}
} // namespace catalog
