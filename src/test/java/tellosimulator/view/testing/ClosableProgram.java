package tellosimulator.view.testing;

import java.io.IOException;
import java.util.List;
import javafx.application.Platform;
import javafx.event.Event;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import tellosimulator.Main;

/** The program as users start it, whose window is closed when something is typed. */
public final class ClosableProgram {

  private ClosableProgram() {}

  /** Takes the arguments of the program. */
  public static void main(String[] args) {
    Thread closer = new Thread(ClosableProgram::closeWhenToldTo, "closer");
    closer.setDaemon(true);
    closer.start();
    Main.main(args);
  }

  private static void closeWhenToldTo() {
    try {
      if (System.in.read() >= 0) {
        Platform.runLater(ClosableProgram::close);
      }
    } catch (IOException e) {
      throw new IllegalStateException("nobody can say when to close", e);
    }
  }

  /** As the window's cross does; later, if the window is not open yet. */
  private static void close() {
    List<Window> windows = List.copyOf(Window.getWindows());
    if (windows.isEmpty()) {
      Platform.runLater(ClosableProgram::close);
    }
    windows.forEach(
        window ->
            Event.fireEvent(window, new WindowEvent(window, WindowEvent.WINDOW_CLOSE_REQUEST)));
  }
}
