// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// How the table of commands writes down its fields: many short names, which mean nothing elsewhere.
#pragma once

#include "protocol/simplebgc/messages.h"

namespace simplebgc::commandtable {

using enum FieldType;

constexpr FieldSpec number(const char *name, FieldType type, const char *unit = "", double scale = 1,
                           std::span<const Choice> words = {})
{
    return {name, type, 1, Elements::One, unit, scale, words, {}};
}

constexpr FieldSpec word(const char *name, FieldType type, std::span<const Choice> words)
{
    return number(name, type, "", 1, words);
}

constexpr FieldSpec axes(const char *name, FieldType type, const char *unit = "", double scale = 1)
{
    return {name, type, 3, Elements::Axes, unit, scale, {}, {}};
}

constexpr FieldSpec xyz(const char *name, FieldType type, const char *unit = "", double scale = 1)
{
    return {name, type, 3, Elements::Xyz, unit, scale, {}, {}};
}

// @param count 0: as often as they fit
constexpr FieldSpec list(const char *name, FieldType type, int count, const char *unit = "", double scale = 1,
                         std::span<const Choice> words = {})
{
    return {name, type, count, Elements::Numbered, unit, scale, words, {}};
}

constexpr FieldSpec bytes(const char *name, int count)
{
    return {name, Bytes, count, Elements::One, "", 1, {}, {}};
}

constexpr FieldSpec reserved(int count)
{
    return bytes("", count);
}

constexpr FieldSpec rest(const char *name)
{
    return bytes(name, 0);
}

constexpr FieldSpec text(const char *name, int size)
{
    return {name, Text, size, Elements::One, "", 1, {}, {}};
}

constexpr FieldSpec group(const char *name, std::span<const FieldSpec> inner, int count,
                          Elements elements = Elements::Numbered)
{
    return {name, Group, count, elements, "", 1, {}, inner};
}

constexpr FieldSpec perAxis(std::span<const FieldSpec> inner)
{
    return group("", inner, 3, Elements::Axes);
}

// Made of bits that have names of their own.
constexpr FieldSpec parts(const char *name, FieldType type, std::span<const BitsSpec> bits)
{
    return {name, type, 1, Elements::One, "", 1, {}, {}, bits};
}

constexpr FieldSpec quaternion(const char *name)
{
    return {name, F32, 4, Elements::Wxyz};
}

constexpr FieldSpec packed(const char *name)
{
    return {name, Quaternion};
}

// --- what is there only if another field says so ---

using IsThere = bool (*)(std::uint32_t told, int element);

constexpr FieldSpec when(const char *other, IsThere isThere, FieldSpec field)
{
    field.when = {other, isThere};
    return field;
}

constexpr FieldSpec when(const char *other, IsThere isThere, std::span<const FieldSpec> fields)
{
    return when(other, isThere, group("", fields, 1, Elements::One));
}

template <unsigned Bit> constexpr bool hasBit(std::uint32_t told, int)
{
    return told >> Bit & 1U;
}

template <unsigned Bit> constexpr bool lacksBit(std::uint32_t told, int)
{
    return !hasBit<Bit>(told, 0);
}

}  // namespace simplebgc::commandtable
