package tellosimulator.board;

import java.util.List;

/**
 * What the matrix shows: a picture that stands, or several that move past. Immutable.
 *
 * @param pictures one beside or below the other
 * @param move where they move
 * @param hertz by how many dots in a second; 0 if they stand
 */
public record MatrixEffect(List<MatrixPicture> pictures, Move move, double hertz) {

  /** Where pictures move. */
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

    /** That of a letter. Documented: SDK 3.0 User Guide; l, r, u and d. */
    public static Move of(char letter) {
      return switch (letter) {
        case 'l' -> LEFT;
        case 'r' -> RIGHT;
        case 'u' -> UP;
        default -> DOWN;
      };
    }
  }

  /** Nothing. */
  public static final MatrixEffect DARK = still(MatrixPicture.DARK);

  public MatrixEffect {
    pictures = List.copyOf(pictures);
  }

  public static MatrixEffect still(MatrixPicture picture) {
    return new MatrixEffect(List.of(picture), Move.NONE, 0);
  }

  /** A text that moves past, again and again. */
  public static MatrixEffect text(String text, MatrixPicture.Color color, Move move, double hertz) {
    List<MatrixPicture> pictures =
        text.chars().mapToObj(each -> MatrixPicture.ofCharacter((char) each, color)).toList();
    return new MatrixEffect(pictures, move, hertz);
  }

  /** Whether it changes by itself. */
  boolean animated() {
    return move != Move.NONE;
  }

  /**
   * What is to be seen: the first picture at the beginning, and a dark one after the last.
   *
   * @param seconds since it began
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
