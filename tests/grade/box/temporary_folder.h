// Folders for what students' programs read and write.
#pragma once

#include <string>

#include "common/base/interrupt.h"

namespace rt::grade
{

/// A fresh folder below the system's folder for temporary files, removed with all in it at the end. Others may enter it, not
/// list it. Throws std::runtime_error.
class TemporaryFolder
{
public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    std::string path;

private:
    void remove() const;

    int lock; ///< held open and locked: says that somebody is still there. Goes with the process, however it ends
    UndoAtInterrupt undo{[this] { remove(); }};
};

/// Removes what killed processes of this user have left: our folders that nobody holds and that are older than a minute.
/// Returns how many.
int removeAbandonedFolders();

} // namespace rt::grade
