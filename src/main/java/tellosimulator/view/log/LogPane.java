package tellosimulator.view.log;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.beans.binding.Bindings;
import javafx.beans.property.BooleanProperty;
import javafx.scene.control.ListView;
import javafx.scene.control.SelectionMode;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.stage.FileChooser;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** The log at the bottom of the window: everything that happens, newest last. */
public final class LogPane extends VBox {

  /** Height of a line in sizes of its font. */
  private static final double LINE_HEIGHT = 1.65;

  private static final KeyCombination COPY =
      new KeyCodeCombination(KeyCode.C, KeyCombination.SHORTCUT_DOWN);

  private final ViewContext context;
  private final LogQueue logQueue;
  private final Language language;
  private final Messages messages;
  private final LogFormat text;
  private final LogModel model;
  private final ListView<LogLine> list = new ListView<>();
  private final LogToolbar toolbar;
  private final AutoScroll tail = new AutoScroll(list);

  /** Shows what comes through {@code logQueue}, from now on. */
  public LogPane(ViewContext context, LogQueue logQueue) {
    this.context = context;
    this.logQueue = logQueue;
    this.language = context.language();
    this.messages = language.messages(LogPane.class);
    this.text = new LogFormat(language, context.simulation().drones().size() > 1);
    this.model = new LogModel(LogModel.CAPACITY, text::searched);
    this.toolbar =
        new LogToolbar(
            language,
            new LogToolbar.Actions(model::clear, this::copy, this::chooseFile),
            Bindings.size(model.shown()));
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

  /** Lets one type what to search. */
  public void startSearch() {
    toolbar.startSearch();
  }

  /** Lets one open the report of the last flight. */
  public void offer(ReportOffer offer) {
    toolbar.offer(offer);
  }

  /** Removes all lines, and those that wait. */
  public void clear() {
    logQueue.drain();
    model.clear();
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
  }

  private void layoutParts() {
    setVgrow(list, Priority.ALWAYS);
    getChildren().addAll(toolbar, list);
  }

  private void setupEventHandlers() {
    context.pulse().onBeat(nanos -> takeIn());
    list.addEventHandler(
        KeyEvent.KEY_PRESSED,
        event -> {
          if (COPY.match(event)) {
            copy();
            event.consume();
          }
        });
  }

  private void setupBindings() {
    toolbar.levelProperty().subscribe(level -> refilter(() -> model.setLevel(level)));
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
            });
  }

  private void takeIn() {
    tail.settle();
    List<LogLine> lines = logQueue.drain();
    if (!lines.isEmpty()) {
      tail.moveOn(model.append(lines));
    }
  }

  private void refilter(Runnable change) {
    list.getSelectionModel().clearSelection();
    change.run();
    tail.moveOn(0);
  }

  /** Copies the selected lines, or all that are shown if none is selected. */
  private void copy() {
    List<LogLine> selected = List.copyOf(list.getSelectionModel().getSelectedItems());
    ClipboardContent content = new ClipboardContent();
    content.putString(
        written(selected.isEmpty() ? model.shown() : selected)
            .collect(Collectors.joining(System.lineSeparator())));
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
      Files.write(file, written(model.shown()).toList());
      logQueue.note(LogLevel.INFO, "saved", file);
    } catch (IOException e) {
      logQueue.say(
          LogLevel.ERROR,
          language -> language.messages(LogPane.class).now("not-saved", file, language.reason(e)));
    }
  }

  private Stream<String> written(List<LogLine> lines) {
    return lines.stream().map(text::whole);
  }
}
