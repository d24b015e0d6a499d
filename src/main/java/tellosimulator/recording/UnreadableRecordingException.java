package tellosimulator.recording;

/** There is nothing to be shown of a folder; the message is a sentence for people. */
public final class UnreadableRecordingException extends Exception {

  private static final long serialVersionUID = 1;

  UnreadableRecordingException(String message) {
    super(message);
  }

  UnreadableRecordingException(String message, Throwable cause) {
    super(message, cause);
  }
}
