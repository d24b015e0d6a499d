package tellosimulator.scenario;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.words.Phrase;

/**
 * Image files that a scenario names; it names them from the folder in which it is.
 *
 * @param folder in which the scenario is
 * @param looked whether a file that is not there is a mistake
 */
record Pictures(Path folder, boolean looked) {

  /** The name of a file, as the program finds it. */
  Value<String> file() {
    return (node, mistakes) -> {
      Optional<String> name = Values.text().read(node, mistakes);
      Optional<Path> file = name.flatMap(this::resolved);
      if (name.isPresent() && file.filter(this::isThere).isEmpty()) {
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

  private boolean isThere(Path file) {
    return !looked || Files.isRegularFile(file);
  }

  private Optional<Path> resolved(String written) {
    try {
      return Optional.of(folder.resolve(written).normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }
}
