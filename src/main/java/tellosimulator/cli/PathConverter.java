package tellosimulator.cli;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the name of a file or a folder. */
enum PathConverter implements ITypeConverter<Path> {
  INSTANCE;

  @Override
  public Path convert(String word) {
    try {
      if (!word.isEmpty()) {
        return Path.of(word);
      }
    } catch (InvalidPathException e) {
      // told below
    }
    throw new TypeConversionException(
        "expected the name of a file or a folder, found " + (word.isEmpty() ? "nothing" : word));
  }
}
