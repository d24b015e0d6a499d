package tellosimulator.scenario;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.words.Phrase;

/** Image files that a scenario names; it names them from the folder in which it is. */
final class Pictures {

  private Pictures() {}

  /** The name of a file that is there, as the program finds it. */
  static Value<String> in(Path folder) {
    return (node, mistakes) -> {
      Optional<String> name = Values.text().read(node, mistakes);
      Optional<Path> file = name.flatMap(written -> resolved(folder, written));
      if (name.isPresent() && file.filter(Files::isRegularFile).isEmpty()) {
        mistakes.add(
            node,
            Phrase.of("expected the name of an image file, found no file %s", Values.found(node)));
        return Optional.empty();
      }
      return file.map(Path::toString);
    };
  }

  /** The name of a file as it is written into a scenario in a folder. */
  static String from(Path folder, String file) {
    Path path = Path.of(file).toAbsolutePath().normalize();
    Path base = folder.toAbsolutePath().normalize();
    boolean near = path.getRoot().equals(base.getRoot());
    return (near ? base.relativize(path) : path).toString().replace('\\', '/');
  }

  private static Optional<Path> resolved(Path folder, String written) {
    try {
      return Optional.of(folder.resolve(written).normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }
}
