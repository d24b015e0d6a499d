package tellosimulator.extension;

import java.util.Map;
import java.util.TreeMap;

/**
 * The lit dots of the matrix. Bit 0 is the upper left dot, bit 7 the upper right one; each row has
 * 8 bits. A dot that is both red and blue appears purple. Immutable.
 */
public record MatrixPicture(long red, long blue) {

  /** The number of rows, and the number of dots in each row. Documented: SDK 3.0 User Guide. */
  public static final int SIZE = 8;

  public static final MatrixPicture DARK = new MatrixPicture(0, 0);

  private static final long HEART =
      rows(0b01100110, 0b11111111, 0b11111111, 0b11111111, 0b01111110, 0b00111100, 0b00011000, 0);

  /** The colour of a dot. */
  public enum Color {
    RED,
    BLUE,
    PURPLE;

    /** Returns the colour for a letter: r, b or p. Documented: SDK 3.0 User Guide. */
    public static Color of(char letter) {
      return letter == 'r' ? RED : letter == 'b' ? BLUE : PURPLE;
    }
  }

  /** Returns a picture whose dots have one colour. */
  private static MatrixPicture of(long dots, Color color) {
    return new MatrixPicture(color == Color.BLUE ? 0 : dots, color == Color.RED ? 0 : dots);
  }

  /**
   * Parses a picture row by row. Each letter stands for a dot: r for red, b for blue, p for purple,
   * and any other letter for a dark dot. Missing dots are dark, and excess letters are ignored.
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

  /**
   * Returns the picture of a character; a dark picture if the font does not contain the character.
   */
  public static MatrixPicture ofCharacter(char character, Color color) {
    return of(MatrixFont.dots(character), color);
  }

  public static MatrixPicture heart(Color color) {
    return of(HEART, color);
  }

  /**
   * Whether a dot is lit in any colour.
   *
   * @param row the row from the top, counted from 0
   * @param column the column from the left, counted from 0
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

  /** Converts rows in reading order to a picture. The highest bit of a row is its leftmost dot. */
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

  /**
   * The font of the dot matrix. Each glyph is 5 dots wide and 7 high. Decided: lower-case letters
   * look like upper-case ones, because so few dots can hardly distinguish them. The glyphs of the
   * real board are unknown.
   */
  private static final class MatrixFont {

    private static final int WIDTH = 5;

    /** The characters, each with its rows from top to bottom. */
    private static final String TABLE =
        """
            A 01110 10001 10001 11111 10001 10001 10001
            B 11110 10001 10001 11110 10001 10001 11110
            C 01110 10001 10000 10000 10000 10001 01110
            D 11100 10010 10001 10001 10001 10010 11100
            E 11111 10000 10000 11110 10000 10000 11111
            F 11111 10000 10000 11110 10000 10000 10000
            G 01110 10001 10000 10111 10001 10001 01111
            H 10001 10001 10001 11111 10001 10001 10001
            I 01110 00100 00100 00100 00100 00100 01110
            J 00111 00010 00010 00010 00010 10010 01100
            K 10001 10010 10100 11000 10100 10010 10001
            L 10000 10000 10000 10000 10000 10000 11111
            M 10001 11011 10101 10101 10001 10001 10001
            N 10001 11001 11001 10101 10011 10011 10001
            O 01110 10001 10001 10001 10001 10001 01110
            P 11110 10001 10001 11110 10000 10000 10000
            Q 01110 10001 10001 10001 10101 10010 01101
            R 11110 10001 10001 11110 10100 10010 10001
            S 01111 10000 10000 01110 00001 00001 11110
            T 11111 00100 00100 00100 00100 00100 00100
            U 10001 10001 10001 10001 10001 10001 01110
            V 10001 10001 10001 10001 01010 01010 00100
            W 10001 10001 10001 10101 10101 11011 10001
            X 10001 01010 01010 00100 01010 01010 10001
            Y 10001 10001 01010 00100 00100 00100 00100
            Z 11111 00001 00010 00100 01000 10000 11111
            0 01110 10001 10011 10101 11001 10001 01110
            1 00100 01100 00100 00100 00100 00100 01110
            2 01110 10001 00001 00110 01000 10000 11111
            3 11111 00010 00100 00110 00001 10001 01110
            4 00010 00110 01010 10010 11111 00010 00010
            5 11111 10000 11110 00001 00001 10001 01110
            6 00110 01000 10000 11110 10001 10001 01110
            7 11111 00001 00010 00010 00100 00100 00100
            8 01110 10001 10001 01110 10001 10001 01110
            9 01110 10001 10001 01111 00001 00010 01100
            . 00000 00000 00000 00000 00000 01100 01100
            , 00000 00000 00000 00000 01100 00100 01000
            : 00000 01100 01100 00000 01100 01100 00000
            ; 00000 01100 01100 00000 01100 00100 01000
            ! 00100 00100 00100 00100 00100 00000 00100
            ? 01110 10001 00001 00110 00100 00000 00100
            - 00000 00000 00000 11111 00000 00000 00000
            + 00000 00100 00100 11111 00100 00100 00000
            * 00000 10101 01110 11111 01110 10101 00000
            / 00001 00001 00010 00100 01000 10000 10000
            = 00000 00000 11111 00000 11111 00000 00000
            _ 00000 00000 00000 00000 00000 00000 11111
            ( 00010 00100 01000 01000 01000 00100 00010
            ) 01000 00100 00010 00010 00010 00100 01000
            < 00010 00100 01000 10000 01000 00100 00010
            > 01000 00100 00010 00001 00010 00100 01000
            # 01010 01010 11111 01010 11111 01010 01010
            % 11001 11001 00010 00100 01000 10011 10011
            ' 00100 00100 01000 00000 00000 00000 00000
            \" 01010 01010 01010 00000 00000 00000 00000
            @ 01110 10001 10111 10101 10110 10000 01111
            & 01100 10010 10100 01000 10101 10010 01101
            $ 00100 01111 10100 01110 00101 11110 00100
            ^ 00100 01010 10001 00000 00000 00000 00000
            | 00100 00100 00100 00100 00100 00100 00100
        """;

    private static final Map<Character, Long> DOTS = read();

    private MatrixFont() {}

    /** Returns the dots of a character, centred in a picture; 0 for an unknown character. */
    static long dots(char character) {
      return DOTS.getOrDefault(Character.toUpperCase(character), 0L);
    }

    private static Map<Character, Long> read() {
      Map<Character, Long> dots = new TreeMap<>();
      for (String line : TABLE.split("\n", -1)) {
        String[] words = line.strip().split(" ", -1);
        int[] rows = new int[words.length - 1];
        for (int i = 0; i < rows.length; i++) {
          rows[i] = Integer.parseInt(words[i + 1], 2) << (MatrixPicture.SIZE - WIDTH - 1);
        }
        if (rows.length > 0) {
          dots.put(words[0].charAt(0), MatrixPicture.rows(rows));
        }
      }
      return dots;
    }
  }
}
