package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.network.AddressPlan;

/** Reads assignments from YAML files. Thread-safe. */
public final class AssignmentFile {

  private AssignmentFile() {}

  /**
   * Reads a file. Does not read the scenarios that it names.
   *
   * @throws ScenarioException if the file cannot be read or contains errors; the exception lists
   *     all of them
   */
  public static Assignment read(Path file) throws ScenarioException {
    Diagnostics diagnostics = new Diagnostics(file.toString());
    Source source = new Source(file.toString(), diagnostics);
    Optional<Node> root = source.bytes(file).flatMap(source::text).flatMap(source::root);
    diagnostics.check();
    Codec.Context context =
        new Codec.Context(
            diagnostics, ScenarioFile.folder(file), true, AddressPlan.MOST_DRONES, CourseDraw.NONE);
    Optional<Assignment> read = AssignmentCodec.CODEC.read(root.orElseThrow(), context);
    diagnostics.check();
    return read.orElseThrow();
  }
}
