/// A stage's last value, kept until what it was made from changes. Nothing is marked dirty by hand.
#pragma once

#include <optional>
#include <utility>

namespace hanei {

template <class Key, class Value>
class StageCache {
public:
    /// The value for `key`: the kept one when the key is equal, else `make()`'s. `make` returns an
    /// optional or a pointer; when that is empty (stopped) nothing is kept and null is returned.
    template <class Make>
    const Value* get(const Key& key, Make&& make) {
        reused_ = value_ && key_ && *key_ == key;
        if (reused_) return &*value_;
        value_.reset();
        auto made = std::forward<Make>(make)();
        if (!made) return nullptr;
        value_.emplace(std::move(*made));
        key_ = key;
        return &*value_;
    }
    bool reused() const { return reused_; }  ///< the last get() made nothing anew
    const Value* now() const { return value_ ? &*value_ : nullptr; }

private:
    std::optional<Key> key_;
    std::optional<Value> value_;
    bool reused_ = false;
};

}  // namespace hanei
