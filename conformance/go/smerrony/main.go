// Flies SMerrony/tello. With HOST and PORT as arguments, the drone is there.
package main

import (
	"fmt"
	"image/jpeg"
	"os"
	"path/filepath"
	"strconv"
	"time"

	"conformance/steps"

	"github.com/SMerrony/tello"
)

func savedPicture(drone *tello.Tello) string {
	folder, err := os.MkdirTemp("", "pictures")
	if err != nil {
		return err.Error()
	}
	defer os.RemoveAll(folder)
	if _, err := drone.SaveAllPics(filepath.Join(folder, "picture")); err != nil {
		return err.Error()
	}
	files, _ := filepath.Glob(filepath.Join(folder, "*"))
	file, err := os.Open(files[0])
	if err != nil {
		return err.Error()
	}
	defer file.Close()
	picture, err := jpeg.Decode(file)
	if err != nil {
		return err.Error()
	}
	return fmt.Sprint(picture.Bounds().Size())
}

func main() {
	drone := new(tello.Tello)
	var err error
	if len(os.Args) > 2 {
		port, _ := strconv.Atoi(os.Args[2])
		err = drone.ControlConnect(os.Args[1], port, 8800)
	} else {
		err = drone.ControlConnectDefault()
	}
	steps.Holds("connect", err, "<nil>")
	pictures, _ := drone.VideoConnectDefault()
	go func() {
		for range pictures {
		}
	}()
	time.Sleep(2 * time.Second)
	steps.Near("battery", float64(drone.GetFlightData().BatteryPercentage), 100, 1)
	drone.GetVersion()
	drone.GetSSID()
	drone.GetMaxHeight()
	time.Sleep(500 * time.Millisecond)
	steps.Holds("version", drone.GetFlightData().Version != "", "true")
	steps.Holds("SSID", drone.GetFlightData().SSID, "TELLO-000001")
	steps.Holds("max. height", drone.GetFlightData().MaxHeight, "30")

	drone.TakeOff()
	steps.Await(func() bool { return drone.GetFlightData().FlyMode == 6 }, 10)
	time.Sleep(time.Second)
	steps.Moved("takeoff", "up", 25, 120)
	flown, _ := drone.AutoFlyToHeight(15)
	<-flown
	time.Sleep(2 * time.Second)
	pose := steps.Moved("AutoFlyToHeight 15", "up", 25, 200)
	steps.Near("told height", float64(drone.GetFlightData().Height), 15, 8) // stops at full speed
	turned, _ := drone.AutoTurnToYaw(90)
	<-turned
	time.Sleep(2 * time.Second)
	pose = steps.Moved("AutoTurnToYaw 90", "up", -30, 30)
	steps.Near("yaw", pose.Yaw, 90, 30) // what arrives late decides when it stops
	steps.Near("told yaw", float64(drone.GetFlightData().IMU.Yaw), pose.Yaw, 5)

	_ = drone.TakePicture()
	steps.Holds("picture", steps.Await(func() bool { return drone.NumPics() == 1 }, 30), "true")
	steps.Holds("size of picture", savedPicture(drone), "(2592,1936)")
	drone.Land()
	stands := steps.Await(func() bool { return drone.GetFlightData().OnGround }, 15)
	steps.Moved("land", "down", 100, 400)
	steps.Holds("stands", stands, "true")
	drone.ControlDisconnect()
	fmt.Println("done")
	os.Exit(0)
}
