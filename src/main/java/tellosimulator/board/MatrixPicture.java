package tellosimulator.board;

/**
 * Which dots of the matrix are lit. Bit 0 is the upper left dot, bit 7 the upper right one; a row
 * has 8 bits. A dot that is red and blue is purple. Immutable.
 */
public record MatrixPicture(long red, long blue) {

  /** Dots of a row, and rows. Documented: SDK 3.0 User Guide. */
  public static final int SIZE = 8;

  public static final MatrixPicture DARK = new MatrixPicture(0, 0);

  private static final long HEART =
      rows(0b01100110, 0b11111111, 0b11111111, 0b11111111, 0b01111110, 0b00111100, 0b00011000, 0);

  /** The colour of dots. */
  public enum Color {
    RED,
    BLUE,
    PURPLE;

    /** That of a letter. Documented: SDK 3.0 User Guide; r, b and p. */
    public static Color of(char letter) {
      return letter == 'r' ? RED : letter == 'b' ? BLUE : PURPLE;
    }
  }

  /** Dots of one colour. */
  private static MatrixPicture of(long dots, Color color) {
    return new MatrixPicture(color == Color.BLUE ? 0 : dots, color == Color.RED ? 0 : dots);
  }

  /**
   * Row by row a letter a dot: r, b, p, and any other for a dark one. What is missing is dark, what
   * is too much is left out.
   */
  public static MatrixPicture ofPattern(String pattern) {
    long red = 0;
    long blue = 0;
    for (int i = 0; i < Math.min(SIZE * SIZE, pattern.length()); i++) {
      char letter = pattern.charAt(i);
      red |= letter == 'r' || letter == 'p' ? 1L << i : 0;
      blue |= letter == 'b' || letter == 'p' ? 1L << i : 0;
    }
    return new MatrixPicture(red, blue);
  }

  /** A character; dark if the board has none of it. */
  public static MatrixPicture ofCharacter(char character, Color color) {
    return of(MatrixFont.dots(character), color);
  }

  public static MatrixPicture heart(Color color) {
    return of(HEART, color);
  }

  /**
   * Whether a dot is lit in some colour.
   *
   * @param row from the top, from 0
   * @param column from the left, from 0
   */
  public boolean lit(int row, int column) {
    return red(row, column) || blue(row, column);
  }

  public boolean red(int row, int column) {
    return ((red >> (SIZE * row + column)) & 1) == 1;
  }

  public boolean blue(int row, int column) {
    return ((blue >> (SIZE * row + column)) & 1) == 1;
  }

  /** Dots as one writes them: the highest bit of a row is its left dot. */
  static long rows(int... rows) {
    long dots = 0;
    for (int row = 0; row < rows.length; row++) {
      for (int column = 0; column < SIZE; column++) {
        long dot = (rows[row] >> (SIZE - 1 - column)) & 1;
        dots |= dot << (SIZE * row + column);
      }
    }
    return dots;
  }
}
