package tellosimulator.extension;

import java.util.List;

/**
 * An effect of the matrix: a still picture, or several scrolling ones. Immutable.
 *
 * @param pictures the pictures, side by side or from top to bottom
 * @param move the direction of scrolling
 * @param hertz the speed of scrolling [dots/s]; 0 for a still picture
 */
public record MatrixEffect(List<MatrixPicture> pictures, Move move, double hertz) {

  /** The direction of scrolling. */
  public enum Move {
    NONE(0, 0),
    LEFT(0, 1),
    RIGHT(0, -1),
    UP(1, 0),
    DOWN(-1, 0);

    private final int rows;
    private final int columns;

    Move(int rows, int columns) {
      this.rows = rows;
      this.columns = columns;
    }

    /** Returns the direction for a letter: l, r, u or d. Documented: SDK 3.0 User Guide. */
    public static Move of(char letter) {
      return switch (letter) {
        case 'l' -> LEFT;
        case 'r' -> RIGHT;
        case 'u' -> UP;
        default -> DOWN;
      };
    }
  }

  /** An effect that keeps the matrix dark. */
  public static final MatrixEffect DARK = still(MatrixPicture.DARK);

  public MatrixEffect {
    pictures = List.copyOf(pictures);
  }

  public static MatrixEffect still(MatrixPicture picture) {
    return new MatrixEffect(List.of(picture), Move.NONE, 0);
  }

  /** Returns an effect that scrolls a text repeatedly. */
  public static MatrixEffect text(String text, MatrixPicture.Color color, Move move, double hertz) {
    List<MatrixPicture> pictures =
        text.chars().mapToObj(each -> MatrixPicture.ofCharacter((char) each, color)).toList();
    return new MatrixEffect(pictures, move, hertz);
  }

  /** Whether the matrix changes with time. */
  boolean animated() {
    return move != Move.NONE;
  }

  /**
   * Returns the visible picture: the first one at the start, and a dark one after the last one has
   * scrolled past. The effect then starts again.
   *
   * @param seconds the time since the start of the effect
   */
  MatrixPicture picture(double seconds) {
    if (!animated()) {
      return pictures.get(0);
    }
    int length = MatrixPicture.SIZE * (pictures.size() + 1);
    int moved = (int) ((long) Math.floor(seconds * hertz) % length);
    long red = 0;
    long blue = 0;
    for (int dot = 0; dot < MatrixPicture.SIZE * MatrixPicture.SIZE; dot++) {
      int row = dot / MatrixPicture.SIZE;
      int column = dot % MatrixPicture.SIZE;
      boolean across = move.columns != 0;
      int along = across ? column + move.columns * moved : row + move.rows * moved;
      int place = Math.floorMod(along, length);
      int index = place / MatrixPicture.SIZE;
      if (index < pictures.size()) {
        int within = place % MatrixPicture.SIZE;
        MatrixPicture picture = pictures.get(index);
        int sourceRow = across ? row : within;
        int sourceColumn = across ? within : column;
        red |= picture.red(sourceRow, sourceColumn) ? 1L << dot : 0;
        blue |= picture.blue(sourceRow, sourceColumn) ? 1L << dot : 0;
      }
    }
    return new MatrixPicture(red, blue);
  }
}
