package tellosimulator.files;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import tellosimulator.words.Phrase;

/** Finds the reason why a file could not be read or written, in words for users. */
public final class IoReason {

  private IoReason() {}

  /** Returns the reason why a file could not be read. */
  public static String ofReading(IOException e) {
    if (e instanceof AccessDeniedException) {
      return "you may not read it";
    }
    if (e instanceof NoSuchFileException) {
      return "there is no such file";
    }
    if (e instanceof IrregularFileException) {
      return "it is a folder, a pipe or a device, not a file";
    }
    return of(e).toString();
  }

  /**
   * Returns the reason for the failure of an operation that reads some files and writes others.
   *
   * @param written the file or folder to be written; every other file is only read
   */
  public static String of(IOException e, Path written) {
    if (!(e instanceof FileSystemException system) || system.getFile() == null) {
      return of(e).toString();
    }
    Path file = Path.of(system.getFile()).toAbsolutePath();
    Path target = written.toAbsolutePath();
    return file.startsWith(target) || target.startsWith(file) // parent folders are created as well
        ? of(e).toString()
        : system.getFile() + " cannot be read: " + ofReading(e);
  }

  /**
   * Returns the reason why a file could not be written: a {@link Phrase}, or a string that is the
   * same in all languages.
   */
  public static Object of(IOException e) {
    if (e instanceof AccessDeniedException denied) {
      return Phrase.of("you may not write to %s", denied.getFile());
    }
    if (e instanceof FileAlreadyExistsException there) {
      return Phrase.of("%s is in the way", there.getFile());
    }
    if (e instanceof IrregularFileException irregular) {
      return Phrase.of("%s is a folder, a pipe or a device, not a file", irregular.getFile());
    }
    if (e instanceof CharacterCodingException) {
      return Phrase.of("it is no text in UTF-8");
    }
    if (e instanceof NoSuchFileException missing) {
      return Phrase.of("there is no folder for %s", missing.getFile());
    }
    if (e instanceof FileSystemException system && system.getReason() != null) {
      return system.getReason();
    }
    return e.getMessage() == null ? Phrase.of("the system does not say why") : e.getMessage();
  }
}
