package tellosimulator.recording;

/** Thrown if a folder contains no readable recording. The message is one sentence for users. */
public final class UnreadableRecordingException extends Exception {

  private static final long serialVersionUID = 1;

  UnreadableRecordingException(String message) {
    super(message);
  }

  UnreadableRecordingException(String message, Throwable cause) {
    super(message, cause);
  }
}
