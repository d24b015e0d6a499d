package tellosimulator.command;

/** What the words of the video commands stand for. Documented: SDK 3.0 User Guide. */
final class VideoWords {

  private VideoWords() {}

  static int fps(String word) {
    return switch (word) {
      case "high" -> 30;
      case "middle" -> 15;
      default -> 5;
    };
  }

  static int lines(String word) {
    return word.equals("high") ? 720 : 480;
  }
}
