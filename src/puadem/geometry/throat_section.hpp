#pragma once
namespace puadem { struct ThroatSection; }
