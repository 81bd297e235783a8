// SPDX-License-Identifier: MIT
// STEP and IGES files read and transferred by Open CASCADE.
#include "bench/files/job.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdlib>
#include <string_view>

namespace {

// Every face once, as often as it may be placed.
template <class Reader>
bench::files::Answer read_by(const char *path, bool areas) {
    Reader reader;
    if (reader.ReadFile(path) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        std::fprintf(stderr, "%s is not read\n", path);
        std::exit(1);
    }
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(reader.OneShape(), TopAbs_FACE, faces);
    bench::files::Answer answer;
    answer.faces = faces.Extent();
    for (int i = 1; areas && i <= faces.Extent(); ++i) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(faces(i), properties, 1e-6);
        answer.area += properties.Mass();
    }
    return answer;
}

bench::files::Answer read(const char *path, bool areas) {
    const std::string_view name = path;
    const bool iges = name.ends_with(".igs") || name.ends_with(".iges");
    return iges ? read_by<IGESControl_Reader>(path, areas) : read_by<STEPControl_Reader>(path, areas);
}

} // namespace

int main(int count, char **arguments) {
    Message::DefaultMessenger()->ChangePrinters().Clear(); // what it says of each file
    return bench::files::run(count, arguments, read);
}
