#include "common/program/command_line.h"

#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace rt
{

namespace
{

/// Whether the whole text is a number.
template <class Number>
bool readNumber(std::string_view text, Number& value)
{
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

template <class Number>
CLI::Validator inRange(Number least, Number most, const char* type)
{
    return {[=](const std::string& text) {
                Number value{};
                const bool isIn = readNumber(text, value) && value >= least && value <= most; // NaN is not
                return isIn ? std::string()
                            : fmt::format("Value {} not in range {:.6g} to {:.6g}", text, double(least), double(most));
            },
            fmt::format("{} in [{:.6g} - {:.6g}]", type, double(least), double(most))};
}

/// Not by the templates of CLI11, which take long to compile. `read` says whether the word could be read.
CLI::Option* add(CLI::App& app, const std::string& name, const char* type, const std::string& help,
                 const std::function<bool(const std::string&)>& read, const std::function<std::string()>& shown)
{
    auto* option = app.add_option(
        name, [read](const CLI::results_t& words) { return read(words.back()); }, help, false, shown);
    return option->type_name(type);
}

} // namespace

Option Option::type(const std::string& name) const
{
    option_->type_name(name);
    return *this;
}

Option Option::oneOf(const std::vector<std::string>& values) const
{
    const auto all = fmt::format("{{{}}}", fmt::join(values, ","));
    option_->check({[values, all](const std::string& text) {
                        const bool isOne = std::find(values.begin(), values.end(), text) != values.end();
                        return isOne ? std::string() : text + " not in " + all;
                    },
                    all});
    return *this;
}

Option Option::range(int least, int most) const
{
    option_->check(inRange(least, most, "INT"));
    return *this;
}

Option Option::range(double least, double most) const
{
    option_->check(inRange(least, most, "FLOAT"));
    return *this;
}

Option Option::check(const std::function<std::string(const std::string&)>& wrong) const
{
    option_->check({[wrong](const std::string& text) { return wrong(text); }, ""});
    return *this;
}

Option Option::existingFile() const
{
    option_->check(CLI::ExistingFile);
    return *this;
}

Option Option::required() const
{
    option_->required();
    return *this;
}

Option Option::count(int words) const
{
    option_->expected(words);
    return *this;
}

Option Option::help(const std::string& text) const
{
    option_->description(text);
    return *this;
}

Option Option::showsDefault() const
{
    option_->capture_default_str();
    return *this;
}

void Option::exclude(const Option& other) const
{
    option_->excludes(other.option_);
}

Option Option::needs(const Option& other) const
{
    option_->needs(other.option_);
    return *this;
}

CommandLine::CommandLine(const std::string& description, const std::string& program)
    : app_(std::make_unique<CLI::App>(description, program))
{
}

CommandLine::~CommandLine() = default;

Option CommandLine::option(const std::string& name, std::string& value, const std::string& help)
{
    const auto read = [&value](const std::string& text) { return value = text, true; };
    return Option(add(*app_, name, "TEXT", help, read, [&value] { return value; }));
}

Option CommandLine::option(const std::string& name, std::optional<std::string>& value, const std::string& help)
{
    const auto read = [&value](const std::string& text) { return value = text, true; };
    return Option(add(*app_, name, "TEXT", help, read, {}));
}

Option CommandLine::option(const std::string& name, int& value, const std::string& help)
{
    const auto read = [&value](const std::string& text) { return readNumber(text, value); };
    return Option(add(*app_, name, "INT", help, read, [&value] { return fmt::to_string(value); }));
}

Option CommandLine::option(const std::string& name, double& value, const std::string& help)
{
    const auto read = [&value](const std::string& text) { return readNumber(text, value); };
    return Option(add(*app_, name, "FLOAT", help, read, [&value] { return fmt::to_string(value); }));
}

Option CommandLine::option(const std::string& name, std::vector<std::string>& values, const std::string& help)
{
    auto* option = app_->add_option(
        name, [&values](const CLI::results_t& words) { return values = words, true; }, help);
    option->type_name("TEXT")->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
    return Option(option);
}

Option CommandLine::flag(const std::string& name, bool& value, const std::string& help)
{
    return Option(app_->add_flag_callback(
        name, [&value] { value = true; }, help));
}

Option CommandLine::operator[](const std::string& name) const
{
    return Option(app_->get_option(name));
}

void CommandLine::footer(const std::string& text)
{
    app_->footer(text);
}

void CommandLine::triesNextPlace()
{
    app_->validate_positionals();
}

std::string CommandLine::program() const
{
    return app_->get_name();
}

bool CommandLine::parse(int argc, const char* const* argv)
{
    try
    {
        app_->parse(argc, argv);
        return true;
    }
    catch (const CLI::Success& help)
    {
        app_->exit(help);
        return false;
    }
    catch (const CLI::ParseError& error)
    {
        throw UsageError(error.what());
    }
}

} // namespace rt
