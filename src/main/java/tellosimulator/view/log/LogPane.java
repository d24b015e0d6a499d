package tellosimulator.view.log;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Node;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.SelectionMode;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.stage.FileChooser;
import tellosimulator.files.AtomicFile;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The log at the bottom of the window: everything that happens, newest last, a command and its
 * answer in one row. Folded, it is the newest row alone. For the JavaFX thread.
 */
public final class LogPane extends VBox {

  /** Height of a line in sizes of its font. */
  private static final double LINE_HEIGHT = 1.65;

  /** Part of the width that details take. Decided: the list keeps commands and replies. */
  private static final double DETAILS = 0.42;

  private static final KeyCombination COPY =
      new KeyCodeCombination(KeyCode.C, KeyCombination.SHORTCUT_DOWN);

  private final ViewContext context;
  private final LogQueue logQueue;
  private final Language language;
  private final Messages messages;
  private final LogFormat text;
  private final LogModel model;
  private final ListView<LogRow> list = new ListView<>();
  private final LogToolbar toolbar;
  private final LogDetails details;
  private final FoldedLog newest;
  private final BooleanProperty open = new SimpleBooleanProperty(this, "open", true);
  private final AutoScroll tail = new AutoScroll(list);

  /** Shows what comes through {@code logQueue}, from now on. */
  public LogPane(ViewContext context, LogQueue logQueue) {
    this.context = context;
    this.logQueue = logQueue;
    this.language = context.language();
    this.messages = language.messages(LogPane.class);
    int drones = context.simulation().drones().size();
    this.text = new LogFormat(language, drones > 1);
    this.model = new LogModel(LogModel.CAPACITY, text::searched);
    this.toolbar =
        new LogToolbar(
            language,
            drones,
            new LogToolbar.Actions(this::clear, this::copy, this::chooseFile, () -> unfold(false)),
            Bindings.size(model.shown()));
    this.details = new LogDetails(text, model, messages);
    this.newest =
        new FoldedLog(
            messages, new LogRowView(text, toolbar.timeStampsProperty()), () -> unfold(true));
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /** Whether lines show their simulated time. */
  public BooleanProperty timeStampsProperty() {
    return toolbar.timeStampsProperty();
  }

  /** Whether all of it is there, rather than the newest row alone. */
  public BooleanProperty openProperty() {
    return open;
  }

  /** Lets one type what to search. */
  public void startSearch() {
    open.set(true);
    toolbar.startSearch();
  }

  /** Lets one open the report of the last flight. */
  public void offer(ReportOffer offer) {
    toolbar.offer(offer);
    newest.offer(offer);
  }

  /** Removes all lines, and those that wait. */
  public void clear() {
    logQueue.drain();
    model.clear();
    details.refresh();
    showNewest();
  }

  /** Hands what it shows to the log that comes after it. */
  public void handOver() {
    logQueue.takeBack(model.lines());
  }

  private void initializeSelf() {
    setId("log");
    getStyleClass().add("log-box");
    getStylesheets().add(LogPane.class.getResource("log.css").toExternalForm());
    logQueue.welcome(
        context.simulation().drones().stream().allMatch(drone -> drone.onProperty().get()));
  }

  private void initializeParts() {
    list.setId("log-list");
    list.setItems(model.shown());
    list.getSelectionModel().setSelectionMode(SelectionMode.MULTIPLE);
    list.setCellFactory(view -> new LogCell(text, toolbar.timeStampsProperty()));
    list.setPlaceholder(messages.label("nothing"));
    list.accessibleTextProperty().bind(messages.text("title"));
  }

  private void layoutParts() {
    HBox body = new HBox(list, details);
    HBox.setHgrow(list, Priority.ALWAYS);
    list.setMinWidth(0);
    details.prefWidthProperty().bind(widthProperty().multiply(DETAILS));
    details.setMinWidth(USE_PREF_SIZE);
    setVgrow(body, Priority.ALWAYS);
    getChildren().addAll(newest, toolbar, body);
    open.subscribe(
        now -> {
          newest.setVisible(!now);
          newest.setManaged(!now);
          toolbar.setVisible(now);
          toolbar.setManaged(now);
          body.setVisible(now);
          body.setManaged(now);
        });
  }

  private void setupEventHandlers() {
    context.pulse().onBeat(nanos -> takeIn());
    list.addEventFilter(KeyEvent.KEY_PRESSED, this::press);
    details.addEventFilter(KeyEvent.KEY_PRESSED, this::closeByEscape);
    list.addEventHandler(MouseEvent.MOUSE_CLICKED, this::click);
    list.getSelectionModel()
        .selectedItemProperty()
        .addListener(
            (property, before, now) -> {
              if (now != null && details.isOpen()) {
                details.open(now);
              }
            });
  }

  private void setupBindings() {
    toolbar.levelProperty().subscribe(level -> refilter(() -> model.setLevel(level)));
    toolbar.droneProperty().subscribe(drone -> refilter(() -> model.setDrone(drone)));
    toolbar.searchProperty().subscribe(wanted -> refilter(() -> model.setText(wanted)));
    // Whole pixels: a list whose lines end between two pixels believes that there is a gap.
    toolbar
        .fontProperty()
        .subscribe(font -> list.setFixedCellSize(snapSizeY(font.getSize() * LINE_HEIGHT)));
    toolbar.autoscrollProperty().bindBidirectional(tail.followingProperty());
    language
        .localeProperty()
        .subscribe(
            locale -> {
              refilter(model::wordsChanged);
              list.refresh();
              details.refresh();
              showNewest();
            });
  }

  private void takeIn() {
    tail.settle();
    List<LogLine> lines = logQueue.drain();
    if (!lines.isEmpty()) {
      tail.moveOn(model.append(lines));
      details.refresh();
      showNewest();
    }
  }

  private void showNewest() {
    List<LogRow> shown = model.shown();
    newest.show(shown.isEmpty() ? Optional.empty() : Optional.of(shown.get(shown.size() - 1)));
  }

  /** Leaves the focus where one can fold again. */
  private void unfold(boolean wanted) {
    open.set(wanted);
    if (wanted) {
      list.requestFocus();
    } else {
      newest.button().requestFocus();
    }
  }

  private void press(KeyEvent event) {
    LogRow selected = list.getSelectionModel().getSelectedItem();
    if (COPY.match(event)) {
      copy();
      event.consume();
    } else if (event.getCode() == KeyCode.ENTER && selected != null) {
      details.toggle(selected);
      event.consume();
    } else {
      closeByEscape(event);
    }
  }

  private void closeByEscape(KeyEvent event) {
    if (event.getCode() == KeyCode.ESCAPE && details.isOpen()) {
      details.close();
      list.requestFocus();
      event.consume();
    }
  }

  /** With Shift or Ctrl, one selects several. */
  private void click(MouseEvent event) {
    boolean plain = !event.isShiftDown() && !event.isShortcutDown() && event.isStillSincePress();
    for (Node node = event.getPickResult().getIntersectedNode();
        node != null && plain && event.getButton() == MouseButton.PRIMARY;
        node = node.getParent()) {
      if (node instanceof ListCell<?> cell && cell.getItem() instanceof LogRow row) {
        details.toggle(row);
        return;
      }
    }
  }

  private void refilter(Runnable change) {
    list.getSelectionModel().clearSelection();
    change.run();
    tail.moveOn(0);
  }

  /** Copies the selected lines, or all that are shown if none is selected. */
  private void copy() {
    List<LogRow> selected = List.copyOf(list.getSelectionModel().getSelectedItems());
    ClipboardContent content = new ClipboardContent();
    content.putString(
        String.join(
            System.lineSeparator(), written(selected.isEmpty() ? model.shown() : selected)));
    Clipboard.getSystemClipboard().setContent(content);
  }

  private void chooseFile() {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(messages.now("save.tooltip"));
    chooser.setInitialFileName(messages.now("save.name"));
    File chosen = chooser.showSaveDialog(getScene().getWindow());
    if (chosen != null) {
      save(chosen.toPath());
    }
  }

  /** Writes the lines that are shown to a file, and a line of the log about it. */
  void save(Path file) {
    try {
      List<String> lines = written(model.shown());
      AtomicFile.write(
          file,
          out -> {
            for (String line : lines) {
              out.write((line + System.lineSeparator()).getBytes(StandardCharsets.UTF_8));
            }
          });
      logQueue.note(LogLevel.INFO, "saved", file);
    } catch (IOException e) {
      logQueue.say(
          LogLevel.ERROR,
          language -> language.messages(LogPane.class).now("not-saved", file, language.reason(e)));
    }
  }

  private List<String> written(List<LogRow> rows) {
    return LogRow.lines(rows).stream().map(text::whole).toList();
  }
}
