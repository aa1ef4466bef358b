// The words behind a program's name. CLI11 does the work, in command_line.cpp alone: it is a header that takes longer to compile
// than any other.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace rt
{

/// A command line that makes no sense, as one sentence. Its programs end with exitBadInput.
struct UsageError : std::runtime_error
{
    using std::runtime_error::runtime_error;

    /// "OPTION: REASON".
    UsageError(const std::string& option, const std::string& reason) : runtime_error(option + ": " + reason) {}
};

/// One option, flag or positional word, of which more can be said: option("--size", size, "...").type("WxH").
class Option
{
public:
    /// What stands for the value in the help, as WxH.
    Option type(const std::string& name) const;
    Option oneOf(const std::vector<std::string>& values) const;
    /// Both ends are allowed.
    Option range(int least, int most) const;
    Option range(double least, double most) const;
    /// `wrong` says in a sentence what is wrong with a value; nothing if it is right.
    Option check(const std::function<std::string(const std::string&)>& wrong) const;
    /// The value is a file that exists.
    Option existingFile() const;
    Option required() const;
    /// Exactly so many words, of a vector.
    Option count(int words) const;
    Option help(const std::string& text) const;
    /// The help says what the value is if nothing is given: what the variable holds now.
    Option showsDefault() const;
    template <class... Others>
    Option excludes(const Others&... others) const
    {
        return (exclude(others), ..., *this);
    }
    Option needs(const Option& other) const;

private:
    friend class CommandLine;
    explicit Option(CLI::Option* wrapped) : option_(wrapped) {}
    void exclude(const Option& other) const;
    CLI::Option* option_;
};

class CommandLine
{
public:
    CommandLine(const std::string& description, const std::string& program);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// A name without dashes is a positional word. The variable must outlive the command line.
    Option option(const std::string& name, std::string& value, const std::string& help);
    Option option(const std::string& name, std::optional<std::string>& value, const std::string& help);
    Option option(const std::string& name, int& value, const std::string& help);
    Option option(const std::string& name, double& value, const std::string& help);
    /// One word or more.
    Option option(const std::string& name, std::vector<std::string>& values, const std::string& help);
    Option flag(const std::string& name, bool& value, const std::string& help);
    /// The option that was added by this name.
    Option operator[](const std::string& name) const;

    /// The end of the help.
    void footer(const std::string& text);
    /// A positional word that fails the checks of one place is tried at the next.
    void triesNextPlace();
    std::string program() const;

    /// Sets the variables. False if help was asked for, which is then on standard output. Throws UsageError.
    bool parse(int argc, const char* const* argv);

private:
    std::unique_ptr<CLI::App> app_;
};

} // namespace rt
